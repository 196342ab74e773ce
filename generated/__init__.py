"""Kernels written by ``nonsmooth regenerate``: do not edit, and import only their extension."""
