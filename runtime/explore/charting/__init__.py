"""Charts of the parameter plane: computed chunk by chunk, kept in a store, resumed."""
