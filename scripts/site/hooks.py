# SPDX-License-Identifier: MIT
"""What MkDocs puts into the pages when it builds them, so that nothing is copied by hand:

    <!-- printed -->                what the code block before it printed (tests/docs/run_blocks.py keeps it in build/site/runs)
    <!-- parameters: NAME ... -->   rows of the parameter table, all without names
    <!-- help: VERB -->             what the program says about a verb, or about itself without one
    <!-- python help: NAME -->      what Python says about a function or class of the package
    <!-- source: FILE NAME -->      a function of src/homolog
    <!-- references: KEY ... -->    entries of docs/references.bib
    ```math and $`...`$             equations, as MathML

Pictures of build/site/pictures appear as pictures/NAME, and no page loads anything from the network. HOMOLOG names the program, HOMOLOG_PYTHON a Python that has the package.
"""
import html
import json
import os
import re
import subprocess
import textwrap
from pathlib import Path

from latex2mathml.converter import convert
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

ROOT = Path(__file__).resolve().parents[2]
MADE = ROOT / "build/site"
RUN_BLOCK = re.compile(r"^```(?:bash|python)\n.*?^```", re.S | re.M)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def printed(text, page):
    """Fills in what each block printed. Blocks are numbered as run_blocks.py numbers them."""
    number, parts, end = 0, [], 0
    for match in re.finditer(r"(?P<block>(?:<!-- not run: .*? -->\n)?" + RUN_BLOCK.pattern + r")|^<!-- printed -->", text, re.S | re.M):
        parts.append(text[end : match.start()])
        end = match.end()
        if match["block"]:
            number += not match["block"].startswith("<!-- not run")
            parts.append(match["block"])
            continue
        file = MADE / "runs" / page.stem / f"{number}.txt"
        if not file.exists():
            raise PluginError(f"{page}: there is no {file}; scripts/build_site.sh makes it")
        parts.append("```{ .text .printed }\n" + file.read_text(encoding="utf-8").rstrip() + "\n```")
    return "".join(parts) + text[end:]


def parameters(names):
    table = json.loads(output_of(os.environ["HOMOLOG"], "params", "--json"))
    rows = [row for row in table if not names or row["name"] in names]
    missing = set(names) - {row["name"] for row in rows}
    if missing:
        raise PluginError(f"there is no parameter {', '.join(sorted(missing))}")
    lines = ["| option | symbol | default | range | meaning |", "|---|---|---|---|---|"]
    for row in rows:
        span = ", ".join(row["choices"]) if "choices" in row else "{:g} to {:g}".format(*row["range"])
        unit = f" {row['unit']}" if row["unit"] else ""
        cells = [f"`--{row['name']}`", row["symbol"].replace("_", r"\_"), f"`{row['value']}`", span + unit, row["sentence"]]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def help_text(verb):
    return "```text\n" + output_of(os.environ["HOMOLOG"], *verb, "--help").rstrip() + "\n```"


def python_help(names):
    code = f"import pydoc, homolog; print(pydoc.plain(pydoc.render_doc(homolog.{names[0]})))"
    return "```text\n" + output_of(os.environ["HOMOLOG_PYTHON"], "-c", code).split("\n", 2)[2].rstrip() + "\n```"


def source(words):
    file, name = words
    text = (ROOT / "src/homolog" / file).read_text(encoding="utf-8")
    found = re.search(rf"^( *)\S[^\n;(]*\b{name}\([^;{{]*{{(?:[^\n]*}}\n|.*?^\1}}\n)", text, re.S | re.M)
    if not found:
        raise PluginError(f"src/homolog/{file} has no '{name}'")
    return "```cpp\n" + textwrap.dedent(found[0]) + f"```\n\nFrom `src/homolog/{file}`."


def references(keys):
    text = (ROOT / "docs/references.bib").read_text(encoding="utf-8")
    lines = []
    for key in keys:
        entry = re.search(rf"^@\w+{{{key},\n(.*?)^}}", text, re.S | re.M)
        if not entry:
            raise PluginError(f"docs/references.bib has no '{key}'")
        fields = dict(re.findall(r"(\w+)\s*=\s*{((?:[^{}]|{[^{}]*})*)}", entry[1]))
        place = next((fields[name] for name in ("journal", "booktitle", "note", "howpublished", "institution") if name in fields), "")
        words = [fields.get("author", "").replace(" and ", "; "), f"*{fields['title']}*", place, fields.get("year", "")]
        line = ". ".join(word.rstrip(".") for word in words if word).replace("{", "").replace("}", "").replace("--", "-")
        lines.append(f"- {line}." + (f" doi:{fields['doi']}" if "doi" in fields else ""))
    return "\n".join(lines)


MACROS = {"source": source, "parameters": parameters, "help": help_text, "python help": python_help, "references": references}


def on_page_markdown(markdown, page, **_):
    markdown = printed(markdown, Path(page.file.src_uri))
    markdown = re.sub(r"^```math\n(.*?)^```", lambda m: f"<div class='math'>{convert(m[1].strip(), display='block')}</div>", markdown, flags=re.S | re.M)
    markdown = re.sub(r"\$`(.+?)`\$", lambda m: convert(m[1]), markdown)
    return re.sub(rf"^<!-- ({'|'.join(MACROS)}):?([\w\s./-]*?) -->", lambda m: MACROS[m[1]](m[2].split()), markdown, flags=re.M)


# Search needs a worker, which a page from a folder may not start; this small script of the theme's author stands in for it.
SHIM_ADDRESS, SHIM = "https://unpkg.com/iframe-worker/shim", "assets/iframe-worker.js"


def on_post_page(output, page, **_):
    return output.replace(SHIM_ADDRESS, "../" * page.url.count("/") + SHIM)


def on_post_template(output_content, template_name, **_):
    return output_content.replace(SHIM_ADDRESS, SHIM) if template_name == "404.html" else output_content


def on_files(files, config, **_):
    files.append(File.generated(config, SHIM, abs_src_path=str(MADE / "npm/node_modules/iframe-worker/shim/index.js")))
    for picture in sorted((MADE / "pictures").glob("*.png")):
        files.append(File.generated(config, f"pictures/{picture.name}", abs_src_path=str(picture)))
    return files
