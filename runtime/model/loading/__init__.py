"""Systems that users declare, read from files, folders and Python.

`nonsmooth.runtime.model.kernels` asks here for every name that is no built-in one.
"""
