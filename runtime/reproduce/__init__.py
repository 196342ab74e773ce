"""The source paper reproduced: every number and figure beside ours."""
