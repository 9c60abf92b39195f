"""What the stub says of settings, written from the table of settings."""
import inkedge

CALLS = {  # a class of keywords: the groups that the call takes
    "LoadSettings": {"output", "picture", "lines", "style", "camera", "model", "limits", "detector"},
    "ArraysSettings": {"output", "picture", "lines", "style", "camera", "model", "limits", "detector"},
    "FrameSettings": {"camera"},
    "LookAtSettings": {"camera"},
    "RenderSettings": {"output", "picture", "lines", "style", "detector"},
    "LinesSettings": {"picture", "lines", "style", "detector"},
}
PARAMETERS = {"ArraysSettings": {"normals"}, "LookAtSettings": {"eye", "target"}}  # no settings there
BEGIN, END = "# settings\n", "# /settings\n"
WIDTH = 120


def literal(names):
    """A Literal of these names, within the width of a line."""
    lines, line = [], "    "
    for name in names:
        text = f'"{name}", '
        if len(line) + len(text) > WIDTH:
            lines.append(line.rstrip())
            line = "    "
        line += text
    return "Literal[\n" + "\n".join([*lines, line.rstrip().removesuffix(",")]) + "\n]"


def annotation(setting):
    if setting.kind == "choice":
        return f"_{camel(setting.name)}"
    if setting.kind == "list":
        return f"str | Sequence[_{camel(setting.name)}]"
    return {"number": "_Number", "count": "_Count", "text": "_Text"}[setting.kind]


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


def section():
    text = ""
    for setting in inkedge.settings.values():
        if setting.choices:
            names = setting.choices
            if setting.name == "maps":
                names = sorted({*names, *(name.replace("-", "_") for name in names)})
            text += f"_{camel(setting.name)}: TypeAlias = {literal(names)}\n"
    for call, groups in CALLS.items():
        text += f"\nclass {call}(TypedDict, total=False):\n    preset: str\n"
        for setting in inkedge.settings.values():
            if setting.group in groups:
                for name in (setting.name, setting.short_name):
                    if name and name not in PARAMETERS.get(call, ()):
                        text += f"    {name}: {annotation(setting)}\n"
    return text + "\n"
