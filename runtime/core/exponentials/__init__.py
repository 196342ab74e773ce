"""Exponentials of matrices and of roots, over each arithmetic."""
