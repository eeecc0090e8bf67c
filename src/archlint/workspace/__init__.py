"""Find: a folder in, the packages and files of a workspace out."""
