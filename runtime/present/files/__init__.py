"""Results in files: written with every digit, refused when they are cut, edited or foreign."""
