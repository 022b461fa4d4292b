"""Following a unit verdict by verdict, and judging it against truth."""
