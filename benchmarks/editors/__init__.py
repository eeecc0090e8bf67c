"""Real editors with the snippets of editors/README.md, and the built VS Code extension in Node, on the broken robot."""
