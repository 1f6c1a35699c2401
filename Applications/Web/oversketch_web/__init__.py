"""oversketch-web: the page on which one draws in a browser. front serves it, visitor is the process that each visitor has."""
