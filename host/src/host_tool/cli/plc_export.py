"""host-tool plc export: the register map as a file for the tool of a PLC or robot controller."""

from pathlib import Path as FilePath

import click

from host_tool.cli.options import Common, common_options
from host_tool.cli.output import print_json
from host_tool.errors import UsageError
from host_tool.plc.formats import FORMATS, REQUEST_NAMES, text_of


@click.command(epilog="Example: host-tool plc export --format siemens --out Tripoint.scl")
@click.option("--format", "form", type=click.Choice(list(FORMATS)), help="The tool.  [default: list the formats]")
@click.option(
    "--request",
    "names",
    type=click.Choice(REQUEST_NAMES),
    multiple=True,
    help="Only what this request reads; may be given several times.  [default: all, for ur what a robot needs]",
)
@click.option("--out", type=click.Path(path_type=FilePath, dir_okay=False), help="File to write.  [default: stdout]")
@common_options
def export(common: Common, form: str | None, names: tuple[str, ...], out: FilePath | None) -> None:
    """Write the registers as tags, data blocks or signals for a PLC's tool.

    No unit is asked: the registers are those of this host-tool's map. The file for Universal Robots names the unit by
    --device. Without --format, lists the formats and the requests.
    """
    if form is None:
        _list(common, names, out)
        return
    text = text_of(FORMATS[form], names, common.address.host)
    if out is not None:
        _write(out, text)
    elif not common.as_json:
        click.echo(text, nl=False)
    if common.as_json:
        lines = text.splitlines() if out is None else len(text.splitlines())
        print_json({"format": form, "tool": FORMATS[form].tool, "file": out and str(out), "lines": lines})


def _list(common: Common, names: tuple[str, ...], out: FilePath | None) -> None:
    if out is not None or names:
        raise UsageError("E-PLC-02", "no format is named", f"add --format with one of {', '.join(FORMATS)}")
    if common.as_json:
        print_json({"formats": {one.name: one.tool for one in FORMATS.values()}, "requests": REQUEST_NAMES})
        return
    for one in FORMATS.values():
        click.echo(f"{one.name:<10}{one.tool} (.{one.ending})")
    click.echo(f"Requests: {', '.join(REQUEST_NAMES)}.")


def _write(file: FilePath, text: str) -> None:
    try:
        file.write_text(text, encoding="utf-8")
    except OSError as error:
        raise UsageError("E-PLC-03", f"cannot write {file} ({error.strerror})", "choose another --out") from error
