"""Holds the books, all *.md of the tree, to what is built: links and their #anchors lead somewhere, commands exist with their options, the
files and sources they name are there, every room stands in the book of the house, whole scenarios validate, and the first one of README.md runs and is read as it says.

Usage: books_test.py FISSURE
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FISSURE = pathlib.Path(sys.argv[1]).resolve()
README_BYTES = 8192
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
PROGRAM = re.compile(r"(?:\S*/)?fissure$")
SCRIPT = re.compile(r"(?:scripts|bench)/\S+$")
RUN_AS_THEY_ARE = {("fissure", "list"), ("fissure", "validate"), ("fissure", "plan")}
complaints, counted = [], {"links": 0, "commands": 0, "sources": 0, "scenarios": 0, "runs": 0}


def complain(book, text):
    complaints.append(f"{book.relative_to(ROOT)}: {text}")


def books():
    return [path for path in sorted(ROOT.rglob("*.md")) if not any(part.startswith((".", "build")) for part in path.relative_to(ROOT).parts)]


def without_code(text):
    """The text with code blocks, indented or fenced, left blank, and these blocks, each a list of lines."""
    prose, blocks, fenced, indented, before = [], [], False, False, ""
    for line in text.split("\n"):
        is_fence = line.startswith("```")
        if not fenced and not before.strip() and not re.match(r"\s*([*-]|\d+\.) ", line):
            was, indented = indented, line.startswith("    ")
            if indented and not was:
                blocks.append([])
        indented = indented and (line.startswith("    ") or not line.strip())
        if is_fence and not fenced:
            blocks.append([])
        is_code = indented or fenced and not is_fence
        if is_code:
            blocks[-1].append(line.removeprefix("    ") if indented else line)
        prose.append("" if is_code or is_fence else line)
        fenced ^= is_fence
        before = line
    return "\n".join(prose), blocks


def anchors(text):
    """As GitHub makes them of headings: lower case, no punctuation, blanks as hyphens, a number where one comes again."""
    seen, found = {}, set()
    for line in without_code(text)[0].split("\n"):
        if not (heading := re.match(r"#{1,6} +(.*)", line)):
            continue
        words = LINK.sub(lambda link: link.group(0)[1:].split("]")[0], heading.group(1)).strip().lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        again = seen[name] = seen.get(name, -1) + 1
        found.add(name if again == 0 else f"{name}-{again}")
    return found


def check_links(book, text):
    for target in LINK.findall(re.sub(r"`[^`]*`", "", without_code(text)[0].replace("[`", "[").replace("`]", "]"))):
        if re.match(r"[a-z]+:", target):
            continue
        counted["links"] += 1
        path, _, anchor = target.partition("#")
        file = (book.parent / path).resolve() if path else book
        if not file.exists():
            complain(book, f"link to {target}: nothing there")
        elif anchor and anchor not in anchors(file.read_text(encoding="utf-8")):
            complain(book, f"link to {target}: no such heading")


def output(*words):
    return subprocess.run(words, capture_output=True, text=True, timeout=60)


class Options:
    """Of each verb, as its help has them."""

    def __init__(self):
        # In the columns of CLI11 a name begins the line after two blanks.
        self.verbs = set(re.findall(r"^  ([a-z]+) ", output(FISSURE, "--help").stdout.partition("ubcommands:")[2], re.MULTILINE))
        self.known = {}

    def of(self, verb):
        if verb not in self.known:
            text = output(FISSURE, verb, "--help").stdout
            for below in re.findall(r"^  ([a-z]+) ", text.partition("ubcommands:")[2], re.MULTILINE):
                text += output(FISSURE, verb, below, "--help").stdout
            self.known[verb] = set(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", text))
        return self.known[verb]


def words_of(line):
    """Of a command line without its comment; brackets and dots of a synopsis are left out."""
    line = re.sub(r"\s#.*", "", line)
    line = re.sub(r"[\[\]|]|\.\.\.", " ", line)
    try:
        return shlex.split(line)
    except ValueError:
        return line.split()


def check_files(book, words):
    for word in words:
        path = word.split("=")[-1].split(":")[0]
        if re.match(r"(configs|scripts|src|tests|bench)/[\w./*-]+$", path) and not list(ROOT.glob(path.rstrip("/"))):
            complain(book, f"{path}: no such file")


def check_command(book, line, options):
    words = words_of(line)
    if words and words[0].endswith("python3"):
        words = words[1:]
    if not words:
        return
    if PROGRAM.match(words[0]) and len(words) > 1:
        counted["commands"] += 1
        if words[1] in ("--help", "--version"):
            return
        if words[1] not in options.verbs and words[1] != "VERB":
            complain(book, f"{line.strip()}: no verb {words[1]}")
            return
        ours = words[2 : words.index("--")] if "--" in words else words[2:]
        for word in ours:
            option = word.split("=")[0]
            if re.match(r"--?[a-zA-Z]", option) and words[1] != "VERB" and option not in options.of(words[1]):
                complain(book, f"{line.strip()}: {words[1]} has no option {option}")
        check_files(book, words[2:])
    elif SCRIPT.match(words[0]):
        counted["commands"] += 1
        script = ROOT / words[0]
        if not script.is_file():
            complain(book, f"{line.strip()}: no such script")
            return
        text = script.read_text(encoding="utf-8")
        for word in words[1:]:
            if word.startswith("--") and word.split("=")[0] not in text:
                complain(book, f"{line.strip()}: {words[0]} has no option {word}")
        check_files(book, [word for word in words[1:] if word != words[0]])


def check_sources(book, text):
    """A source that is named stands where the book says: from the root, from src/, from a wing or beside the book."""
    wings = [wing for wing in (ROOT / "src").iterdir() if wing.is_dir()]
    for path in re.findall(r"`((?:[\w.-]+/)+[\w.-]+\.(?:h|cpp|py|md|cmake))`", text):
        counted["sources"] += 1
        if not any((folder / path).is_file() for folder in [ROOT, ROOT / "src", book.parent, *wings]):
            complain(book, f"{path}: no such source")


def check_rooms(book):
    """The book of the house has every room."""
    known = set(re.findall(r"\]\(([\w/]+)\) \|", book.read_text(encoding="utf-8")))
    src = ROOT / "src"
    rooms = {f"{wing.name}/{room.name}" for wing in src.iterdir() if wing.is_dir() and wing.name != "main" for room in wing.iterdir() if room.is_dir()}
    for room in sorted(rooms | {"main"}):
        if room not in known:
            complain(book, f"room {room} is not in the table")


def check_inline(book, text, options):
    for code in re.findall(r"(?<!`)`([^`\n]+)`(?!`)", text):
        if re.match(r"(fissure [a-z]|scripts/|/usr/bin/python3 scripts/)", code) and "*" not in code and "<" not in code:
            check_command(book, code, options)


def run_cheap(book, line):
    words = words_of(line)
    if tuple(words[:2]) not in RUN_AS_THEY_ARE or not all((ROOT / word).is_file() for word in words[2:]):
        return
    counted["runs"] += 1
    ended = subprocess.run([FISSURE, *words[1:]], cwd=ROOT, capture_output=True, text=True, timeout=60)
    if ended.returncode != 0:
        complain(book, f"{line.strip()}: exit code {ended.returncode}: {ended.stderr.strip()}")


def check_scenario(book, block, folder):
    """Blocks that are a scenario are sound."""
    text = "\n".join(block) + "\n"
    if not text.startswith("format: 1") or "\nbodies:" not in text or "..." in text:
        return None
    counted["scenarios"] += 1
    file = pathlib.Path(folder) / (re.search(r"^name: (\w+)", text, re.MULTILINE).group(1) + ".yaml")
    file.write_text(text, encoding="utf-8")
    ended = output(FISSURE, "validate", str(file))
    if ended.returncode != 0:
        complain(book, f"scenario {file.name}: {ended.stderr.strip()}")
    return file


def check_first(book, scenario, blocks, folder):
    """README's own scenario runs, and its result is read as the book says."""
    ended = subprocess.run([FISSURE, "run", scenario], cwd=folder, capture_output=True, text=True, timeout=120)
    if ended.returncode != 0:
        complain(book, f"{scenario.name}: run ends with {ended.returncode}: {ended.stderr.strip()}")
        return
    for block in blocks:
        if block[0] != "import xarray":
            continue
        counted["runs"] += 1
        read = subprocess.run([sys.executable, "-c", "\n".join(block)], cwd=folder, capture_output=True, text=True, timeout=60)
        if read.returncode != 0 or not re.match(r"[\d.e-]+ mm\n", read.stdout):
            complain(book, f"reading the result: {read.stdout}{read.stderr.strip()[-200:]}")


def main():
    options = Options()
    if len(options.verbs) < 10:
        raise SystemExit(f"the verbs were not understood: {sorted(options.verbs)}")
    with tempfile.TemporaryDirectory() as folder:
        for book in books():
            text = book.read_text(encoding="utf-8")
            check_links(book, text)
            _, blocks = without_code(text)
            check_inline(book, text, options)
            check_sources(book, text)
            for block in blocks:
                for line in block:
                    check_command(book, line, options)
                    run_cheap(book, line)
                scenario = check_scenario(book, block, folder)
                if scenario and book == ROOT / "README.md":
                    check_first(book, scenario, blocks, folder)
    check_rooms(ROOT / "src/README.md")
    size = (ROOT / "README.md").stat().st_size
    if size > README_BYTES:
        complain(ROOT / "README.md", f"{size} bytes, more than {README_BYTES}")
    print(", ".join(f"{count} {what}" for what, count in counted.items()))
    if min(counted["links"] - 200, counted["commands"] - 100, counted["sources"] - 20, counted["scenarios"] - 2, counted["runs"] - 3) < 0:
        complaints.append("the books were not understood: too few of something")
    print("\n".join(complaints), end="\n" if complaints else "")
    raise SystemExit(1 if complaints else 0)


main()
