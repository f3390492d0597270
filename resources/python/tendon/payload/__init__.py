"""Values, their types, and their bytes."""
