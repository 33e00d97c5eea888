"""The errors that a user's input can cause."""


class MeshError(ValueError):
    """Input that cannot be meshed.

    code -- stable identifier of what is wrong ("non_manifold_edges", "invalid_source", "unreadable_file", ...)
    kind -- what `ids` count: "vertex", "edge" (two vertex ids an edge), "facet" or "none"
    ids  -- 0-based indices of the offending elements of the input
    """

    def __init__(self, message, code="invalid_input", kind="none", ids=()):
        super().__init__(message)
        self.code = code
        self.kind = kind
        self.ids = list(ids)

    def __str__(self):
        """The message, and the first of the offending elements."""
        message = super().__str__()
        if not self.ids:
            return message
        shown = ", ".join(map(str, self.ids[:10])) + (", …" if len(self.ids) > 10 else "")
        return f"{message} ({self.kind} {shown})"


class Cancelled(MeshError):
    """The progress function, or the user, ended the run."""
