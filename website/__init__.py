"""The documentation site: its pages are made of the documents, the rule book and the program; nothing is written twice.

``python -m website FOLDER`` writes the sources of the site; ``make docs`` does that and builds it.
"""
