"""The sections of a document, each by a module of its own."""
