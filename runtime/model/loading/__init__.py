"""Systems that users declare, from files, folders and Python.

===========  ==============================================================
`declared`   what a declaration offers, and the file that holds it
`load`       a file, a folder or a System to a module of tables and kernels
`caching`    derivations that are kept from one process to the next
`folder`     the folder that `nonsmooth generate` writes
`compiling`  its kernels in C
===========  ==============================================================

`nonsmooth.runtime.model.kernels` asks here for every name that is no built-in one.
"""
