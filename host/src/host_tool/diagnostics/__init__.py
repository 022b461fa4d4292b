"""Finding out why something is wrong."""
