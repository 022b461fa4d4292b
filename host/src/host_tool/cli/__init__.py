"""Command line: reads options, calls one library function, prints, sets the exit code."""
