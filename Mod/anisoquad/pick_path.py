"""A path that grows by picks on a surface: what clicks mean, without a window. No FreeCAD."""


class PickPath:
    """The path that is being picked on a SurfaceLines.

    vertices -- ids in order; the first is also the last when the path is closed
    """

    def __init__(self, lines, vertices=()):
        self.lines = lines
        self.vertices = list(vertices)
        self._before = list(vertices)

    @property
    def closed(self):
        return len(self.vertices) > 2 and self.vertices[0] == self.vertices[-1]

    @property
    def edge_count(self):
        return max(len(self.vertices) - 1, 0)

    @property
    def length(self):
        return self.lines.length(self.vertices) if self.vertices else 0.0

    def click(self, edge):
        """Start with an edge (from, to), or extend the path to it by the best way. False when that would cross the path."""
        self._before = list(self.vertices)
        if not self.vertices:
            self.vertices = list(edge)
            return True
        if self.closed or self._has_edge(edge):
            return False
        at_end, at_start = self._extension(self.vertices[-1], edge), self._extension(self.vertices[0], edge)
        if not at_end or (at_start and self.lines.length(at_start) < self.lines.length(at_end)):
            return self._grow(at_start, front=True)
        return self._grow(at_end, front=False)

    def take_line(self, edge):
        """Take the whole feature line or ridge through an edge; it joins the path where their ends meet, else it replaces it."""
        self._before = list(self.vertices)
        line = self.lines.whole_line(edge)
        self.vertices = _joined(self.vertices, line) or line

    def remove(self, edge):
        """Cut the path at an edge, and keep the longer part; a closed path is opened there. False when the edge is not on it."""
        index = self._edge_index(edge)
        if index is None:
            return False
        self._before = list(self.vertices)
        if self.closed:
            self.vertices = self.vertices[index + 1 : -1] + self.vertices[: index + 1]
            return True
        parts = self.vertices[: index + 1], self.vertices[index + 1 :]
        longer = max(parts, key=lambda part: (self.lines.length(part), len(part)))
        self.vertices = longer if len(longer) > 1 else []
        return True

    def take_back(self):
        """Undo the last pick."""
        self.vertices = list(self._before)

    def clear(self):
        self._before, self.vertices = list(self.vertices), []

    def _extension(self, end, edge):
        """The best way from an end of the path to the far end of an edge, over the edge."""
        ways = [self.lines.best_path(end, vertex) for vertex in edge]
        if not all(ways):
            return []
        near = min(ways, key=self.lines.length)
        far = edge[0] if near[-1] == edge[1] else edge[1]
        return near if far in near else [*near, far]

    def _grow(self, way, front):
        """Add a way that begins at one end of the path; it may close the path, but not meet it elsewhere."""
        ordered = self.vertices[::-1] if front else self.vertices
        new = []
        for vertex in way[1:]:
            new.append(vertex)
            if vertex == ordered[0]:
                break
            if vertex in ordered:
                return False
        if not new:
            return False
        grown = ordered + new
        self.vertices = grown[::-1] if front else grown
        return True

    def _edge_index(self, edge):
        wanted = set(edge)
        pairs = zip(self.vertices[:-1], self.vertices[1:])
        return next((index for index, pair in enumerate(pairs) if set(pair) == wanted), None)

    def _has_edge(self, edge):
        return self._edge_index(edge) is not None


def _joined(path, line):
    """The path with a line at one of its ends, or None when they do not meet there, or cross."""
    if not path or path[0] == path[-1] or line[0] == line[-1]:
        return None
    for way in (line, line[::-1]):
        if path[-1] == way[0] and not set(path[1:]) & set(way[1:]):
            return path + way[1:]
        if path[0] == way[-1] and not set(path[:-1]) & set(way[:-1]):
            return way + path[1:]
    return None
