"""Paths with known truth: closed forms and trajectory files."""
