"""Systems that users declare, read from files, folders and Python.

===========  =======================================================================================
`declared`   declarations of users: what they have to offer, and the files that hold them
`load`       modules of tables and kernels beside the built-in ones: of declarations, files, folders
`caching`    results of derivations, kept in the user's cache folder from one process to the next
`compiling`  compiled kernels in a folder of `nonsmooth generate`
`folder`     the folder of a user's kernels: written by `nonsmooth generate`, and by nothing else
===========  =======================================================================================

`nonsmooth.runtime.model.kernels` asks here for every name that is no built-in one.
"""
