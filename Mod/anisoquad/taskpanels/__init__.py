"""Task panels: what is shown beside the view while an object is edited."""
