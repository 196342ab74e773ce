"""The commands that prove, and check what was proved."""
