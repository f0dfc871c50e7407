# Install rules: see the project helper.
