# Groups of checks: each is run, timed, logged and counted; one table at the end. Sourced, not run.
# Requires: log_dir, an existing folder.

group_names=()
declare -A group_seconds=() group_passed=() group_failed=() group_skipped=()

# group NAME COMMAND...: runs the command (a program or a function) with its output in a log. A command that
# ends in ctest's summary counts its tests, any other counts as one. Returns 0 whatever happens: ask `passed`.
group() {
  local name=$1 log="$log_dir/$1.log" start=$EPOCHREALTIME code=0
  shift
  printf '%-11s ' "$name"
  # Not in a condition: bash ignores errexit inside those, and a failing line would go unseen.
  set +e
  (set -e; "$@") >"$log" 2>&1 </dev/null
  code=$?
  set -e
  group_names+=("$name")
  group_seconds[$name]=$(seconds_since "$start")
  count_results "$name" "$code" "$log"
  tell_result "$name" "$log"
}

passed() { [ "${group_failed[$1]:-1}" -eq 0 ]; }

seconds_since() { awk -v a="$1" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }'; }

# From ctest's "90% tests passed, 2 tests failed out of 20", else from the exit code.
count_results() {
  local name=$1 code=$2 log=$3 total=1 failed=0 skipped
  [ "$code" -eq 0 ] || failed=1
  if [[ "$(grep -E '^[0-9]+% tests passed' "$log")" =~ ([0-9]+)\ tests\ failed\ out\ of\ ([0-9]+) ]]; then
    failed=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
    [ "$code" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1
  fi
  skipped=$(grep -cE '\*\*\*Skipped' "$log" || true)
  group_failed[$name]=$failed
  group_skipped[$name]=$skipped
  group_passed[$name]=$((total - failed - skipped))
}

# One line when all is well, the end of the log when not.
tell_result() {
  local name=$1 log=$2
  if passed "$name"; then
    printf 'ok      %8s s\n' "${group_seconds[$name]}"
  else
    printf 'FAILED  %8s s; the end of %s:\n' "${group_seconds[$name]}" "$log"
    tail -n 80 "$log" | sed 's/^/    /'
  fi
}

# Seconds by module, from ctest's summary by label.
show_labels() {
  sed -nE 's/^([a-z_0-9]+) +=.* ([0-9.]+) sec\*proc \(([0-9]+) tests?\)/    \1 \2 \3/p' "$log_dir/$1.log" |
    awk '{ printf "    %-12s %8.1f s in %4d tests\n", $1, $2, $3 }'
}

# The table, and the closing line. Returns 1 if anything failed.
report_groups() {
  local name all_passed=0 all_failed=0 all_skipped=0
  printf '\n%-11s %9s %8s %8s %8s\n' group seconds passed failed skipped
  for name in "${group_names[@]}"; do
    printf '%-11s %9s %8d %8d %8d\n' "$name" "${group_seconds[$name]}" "${group_passed[$name]}" \
      "${group_failed[$name]}" "${group_skipped[$name]}"
    all_passed=$((all_passed + group_passed[$name]))
    all_failed=$((all_failed + group_failed[$name]))
    all_skipped=$((all_skipped + group_skipped[$name]))
  done
  printf '\n%d passed, %d failed' "$all_passed" "$all_failed"
  [ "$all_skipped" -eq 0 ] || printf ', %d skipped' "$all_skipped"
  printf '\n'
  [ "$all_failed" -eq 0 ]
}
