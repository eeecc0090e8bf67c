"""What editors ask about ROS names: hover, definition, references, completion, renaming, links.

Everything here is told from what one run knows (:class:`Index`, made once for a run) and from the texts as the editor
has them (:class:`Texts`).  A position is the shown path of a file with a line and a column from 1; what is not known is
an empty answer.
"""
