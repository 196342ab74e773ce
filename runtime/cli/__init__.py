"""The command line: what each command reads, asks and shows."""
