"""One self-contained HTML page: the graph of each system, to be searched, filtered and walked through.

``contents`` says what is in the page, ``places`` where each shape stands, ``document`` puts it together with the
scripts and the style beside this file.  ``vendor`` has the libraries that the page brings along, which
``scripts/vendor_page_library`` writes: d3-zoom for the gestures, dagre to arrange anew what is shown.
"""
