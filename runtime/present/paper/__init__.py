"""The source paper reproduced: every number, figure and claim beside ours."""
