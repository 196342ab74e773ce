"""The sections of a document, each by the module `describe_TOPIC` that writes it."""
