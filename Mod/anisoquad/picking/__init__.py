"""Picking in the 3D view. What picks mean is in pick_path and surface_lines, without a window."""
