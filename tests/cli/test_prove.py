"""prove: all claims, as the documents record them."""

import json

from program import ProgramTest, main

# The claims with a known difference, explained in docs/decisions.
DIFFERING = {"balanced-octree", "size-step", "figure-8-size-step", "figure-8-runs"}


class Prove(ProgramTest):
    def test_all_claims_are_as_recorded(self):
        result = self.succeed("prove", "all", "--json", "proofs.json", "--quiet")
        report = json.loads((self.folder / "proofs.json").read_text())
        self.assertEqual(report["command"], "prove")
        self.assertEqual(report["exit_code"], 0)
        self.assertGreaterEqual(len(report["claims"]), 18)
        for claim in report["claims"]:
            with self.subTest(claim=claim["id"]):
                self.assertTrue(claim["as_recorded"])
                self.assertEqual(claim["verdict"], "differs" if claim["id"] in DIFFERING else "holds")
                self.assertTrue(claim["parts"])
                self.assertIn(f"{claim['id']}: {claim['verdict']}", result.stdout)
                for part in claim["parts"]:
                    self.assertEqual(part["verdict"] == "holds", part["explained_in"] is None)

    def test_one_claim(self):
        report = json.loads(self.succeed("prove", "lemma-5", "--json", "-").stdout)
        (claim,) = report["claims"]
        self.assertEqual(claim["source"], "Lemma 5, Figure 3")
        self.assertTrue(any("244 tetrahedra" in part["found"] for part in claim["parts"]))

    def test_list(self):
        listed = self.succeed("prove", "--list").stdout
        for name in ["lemma-6", "theorem-8", "table-1", "octree-keys"]:
            self.assertIn(name, listed)

    def test_unknown_claim(self):
        self.refuse(2, "prove", "lemma5", saying=["lemma5", "did you mean lemma-5?", "--list"])


if __name__ == "__main__":
    main()
