"""Common to all tests: one thread a process for linear algebra, whose threads would compete."""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
