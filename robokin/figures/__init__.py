"""The live figures of the chapters, one module a topic."""
