"""What was measured against its yardstick, as rows of a table."""

from dataclasses import dataclass, field


@dataclass
class Row:
    metric: str
    value: str
    yardstick: str = "-"
    ratio: float | None = None
    target: str = "-"  # "<= 1.2" or ">= 0.9"
    verdict: str = ""
    details: dict = field(default_factory=dict)

    def judge(self):
        if self.target == "-":
            return self
        if self.ratio is None:
            self.verdict = self.verdict or "not measured"
            return self
        relation, limit = self.target.split()
        met = self.ratio <= float(limit) if relation == "<=" else self.ratio >= float(limit)
        self.verdict = "met" if met else "MISSED"
        return self


def ms(value):
    return f"{value:.0f} ms" if value >= 100 else f"{value:.1f} ms" if value >= 1 else f"{value:.3f} ms"


def mb(value):
    return f"{value / 1e6:.0f} MB"


def against(metric, value, yardstick_name, yardstick, target="-", missing="not measured"):
    """A row for two times in milliseconds, either of which may be missing."""
    if value is None:
        return None
    if yardstick is None:
        return Row(metric, ms(value), missing, None, target, details={"ms": value}).judge()
    text = f"{yardstick_name} {ms(yardstick)}"
    details = {"ms": value, "yardstick_ms": yardstick}
    return Row(metric, ms(value), text, value / yardstick, target, details=details).judge()


def print_columns(header, rows):
    widths = [max(len(str(row[i])) for row in [header, *rows]) for i in range(len(header))]
    for row in [header, ["-" * width for width in widths], *rows]:
        print("  ".join(str(cell).ljust(width) for cell, width in zip(row, widths)).rstrip())


def print_table(title, rows):
    print(f"\n{title}")
    cells = [
        [r.metric, r.value, r.yardstick, "-" if r.ratio is None else f"{r.ratio:.3g}", r.target, r.verdict]
        for r in rows
    ]
    print_columns(["metric", "value", "yardstick", "ratio", "target", ""], cells)
