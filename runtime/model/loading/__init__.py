"""Systems that users declare, read from files, folders and Python.

============  ======================================================================================
`declared`    declarations of users: what they have to offer, and the files that hold them
`load`        tables and kernels beside the built-in ones: of declarations, files, folders
`caching`     what was derived and compiled, kept in the user's cache folder between processes
`background`  compiled kernels of declarations, made by another process beside the work
`growing`     systems whose configurations are made when they are first visited
`modules`     emitted text as a module, and the modules that a process knows
`compiling`   an extension from emitted C files, by the compiler of this Python
`extensions`  compiled kernels in files: found in a folder, loaded
`folder`      the folder of a user's kernels: written by `nonsmooth generate`, and by nothing else
============  ======================================================================================

`nonsmooth.runtime.model.kernels` asks here for every name that is no built-in one.
"""
