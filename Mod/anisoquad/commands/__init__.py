"""Commands: what menus and tool bars call. Each is one class in a module of its own."""


def all_commands():
    """One object of each command, in the order of the tool bar; None is a separator."""
    from .add_source_command import AddSourceCommand
    from .edit_command import EditCommand
    from .export_command import ExportCommand
    from .preferences_command import PreferencesCommand
    from .quad_mesh_command import QuadMeshCommand
    from .quality_command import QualityCommand
    from .suggest_sources_command import SuggestSourcesCommand

    return [QuadMeshCommand(), AddSourceCommand(), SuggestSourcesCommand(), EditCommand(), None, QualityCommand(), ExportCommand(),
            None, PreferencesCommand()]
