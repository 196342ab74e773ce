"""Results for people and for files: JSON, pictures, notebooks, the report of the paper."""
