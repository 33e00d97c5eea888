"""View providers: the GUI's side of document objects."""
