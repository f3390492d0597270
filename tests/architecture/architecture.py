#!/usr/bin/env python3
"""architecture.py ROOT: checks that the source tree follows the rules of its architecture.

A rule is a function that takes a file and yields its violations as (line number, sentence); rules of folders take the
folder and its files, rules of the tree all files. They read text, not C++: includes, macros, sizes.
architecture_test.py shows what each of them catches.
"""

import os
import re
import sys
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path, PurePosixPath

MAX_FUNCTION_LINES = 60

# Folders of core/tendon, the lowest row first. A folder may include folders of lower rows.
CORE_ROWS = (("base",), ("lockfree", "payload"), ("state",), ("interface",), ("task",), ("manager",))
NETWORK_ROWS = (("security",), ("middleware",), ("proxy",), ("process",), ("gcm",), ("recording",))
ROWS = (*CORE_ROWS, *NETWORK_ROWS, ("ice",))
ALL_OF_CORE = "core/tendon/tendon.h"
HEIGHT = {folder: height for height, row in enumerate(ROWS) for folder in row}
CORE = {folder for row in CORE_ROWS for folder in row}

# The other parts that each part of the tree may include.
PARTS = {
    "core": {"core"},
    "components": {"core", "components"},
    "program": {"core", "program"},
    "lcm": {"core", "program", "lcm"},
    "gcm_console": {"core", "program", "gcm_console"},
    "gcm_gui": {"core", "program", "gcm_console", "gcm_gui"},
}

ICE = re.compile(r"(Ice\w*|Glacier2)/")
QT = re.compile(r"Q[A-Za-z]\w*(/.*)?$|q\w+\.h$")
OPERATING_SYSTEM = re.compile(
    r"(sys|linux|netinet|arpa|net|mach|asm|bits)/"
    r"|(unistd|fcntl|poll|pthread|sched|semaphore|signal|dlfcn|netdb|ifaddrs|pwd|grp|dirent|termios|spawn"
    r"|execinfo|syslog|windows|winsock2|io)\.h$")
ICE_HOMES = ("core/tendon/ice", "tests/core/ice", "tests/benchmarks/remote")
QT_HOMES = ("gcm_gui", "tests/gcm_gui", "tests/system", "tests/benchmarks/window")
# Components that also use tendon::network: a recorder is a viewer of its own process.
NETWORK_COMPONENTS = ("components/recorder",)
ATOMIC_HOMES = ("core/tendon/lockfree", "core/tendon/state", "core/tendon/base/os")

INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')
OPENS_BODY = re.compile(r"^(?! *//).*[)\w>&*] \{$|^ *\{$")
ENDS_STATEMENT = re.compile(r"[;{}]$|^\s*$|^\s*(//|#|(public|protected|private|signals|.* slots):$)")
OPENS_NAMESPACE = re.compile(r"(?:inline )?namespace ?([\w:]*) ?\{$")
DEFINES_TYPE = re.compile(r"(?:class|struct|union|enum class|enum) (?:\[\[\w+\]\] )?(\w+)(?: final)?(?: :.*| \{.*)?$")
PRIVATE_NAME = re.compile(r"(?:constexpr|constinit|const|static|thread_local)\b[^=({]*?\b(k\w+)\b"
                          r"|using (\w+) =|(?:class|struct|enum class) (\w+)\b(?!;)")
NO_FUNCTION = re.compile(r"\s*(inline namespace|namespace|class|struct|enum|union|extern|export)\b")
NO_NAMED_FUNCTION = re.compile(r"namespace|class|struct|enum|union|using|static_assert|friend|extern|concept|template <"
                               r"|return|[#/}{ \t]")
TEMPLATE_ARGUMENTS = re.compile(r"<[^<>()]*(?:\([^()]*\))?[^<>()]*>")
FUNCTION_NAME = re.compile(r"(?:^|[\s&*>])(?!operator$)(\w*[a-z]\w*)$")
LISTS_SOURCES = re.compile(r"^\s*(?:add_library|add_executable|target_sources|tendon_test|tendon_component)"
                           r"\(\s*([\w-]+)([^()]*)\)", re.M)
FILE_SET = re.compile(r"FILE_SET (\w+) (?:TYPE HEADERS )?BASE_DIRS \S+\s+FILES\s+((?:[\w/]+\.h\s*)+)")
# The page with tables of all folders. A heading such as "### The window: `gcm_gui`" names the parent of the folders.
FOLDER_PAGE = "docs/architecture.md"
DESCRIBED = ("core/tendon", "gcm_gui", "gcm_console")
NAMES_PARENT = re.compile(r"### .*`([\w/]+)`$")
NAMES_LAYER = re.compile(r"  (\w+) {2,}\S")  # in README.md
NAMES_FOLDER = re.compile(r"\| `([\w/]+)` \|")
# The page with the folders that have no counterpart between tests/ and the code.
TEST_PAGE = "tests/README.md"
MIRRORED = (*DESCRIBED, "lcm", "program")

# The folders in which test names must not begin like a question.
PLAIN_TESTS = ("tests",)
RIDDLE = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)"
                    r"\(\s*\w+,\s*((?:What|Who|Whoever|Whom|Whose|Which|That)[A-Z]\w*)", re.M)

# Names of namespace std, with the headers that declare them by the standard; the first is the one to include.
# Names with overloads in many headers are left out, such as swap, get and hash.
STANDARD_HEADERS = {re.compile(rf"\bstd::(?:{names})\b"): headers for names, headers in {
    "size_t": ("cstddef", "cstdio", "cstdlib", "cstring", "ctime", "cwchar"),
    "byte|max_align_t|nullptr_t|ptrdiff_t|to_integer": ("cstddef",),
    r"u?int(?:_fast|_least)?\d+_t|u?int(?:max|ptr)_t": ("cstdint", "cinttypes"),
    "array|to_array": ("array",),
    r"atomic\w*|memory_order\w*": ("atomic",),
    "chrono|chrono_literals": ("chrono",),
    "function|reference_wrapper|c?ref|invoke|bind_front|mem_fn|not_fn|less|greater|equal_to": ("functional",),
    "map|multimap": ("map",),
    r"(?:unique|shared|weak)_ptr|make_(?:unique|shared)\w*|\w+_pointer_cast|enable_shared_from_this|default_delete"
    "|align|addressof|to_address|construct_at|destroy_at|allocator|allocator_traits": ("memory",),
    r"(?:recursive_|timed_)?mutex|lock_guard|(?:unique|scoped|defer|adopt|try_to)_lock|once_flag|call_once": ("mutex",),
    "optional|make_optional|nullopt|nullopt_t": ("optional",),
    "span|as_bytes|as_writable_bytes|dynamic_extent": ("span",),
    "string|basic_string|to_string|getline|sto[dfil]|stou?ll?": ("string",),
    "string_view|basic_string_view": ("string_view",),
    r"(?:is|has)_\w+_v|(?:add|make|remove)_\w+_t|(?:common_type|conditional|decay|enable_if|invoke_result)_t"
    "|(?:type_identity|underlying_type|void)_t|(?:true|false)_type|(?:bool|integral)_constant": ("type_traits",),
    r"move|forward|exchange|as_const|declval|pair|make_pair|in_place|in_range|cmp_\w+|\w*(?:index|integer)_sequence\w*":
        ("utility",),
    r"variant|variant_\w+|visit|holds_alternative|get_if|monostate": ("variant",),
    "vector": ("vector",),
}.items()}
COMMENT_OR_LITERAL = re.compile(r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\B'(?:\\.|[^'\\\n])+'""",
                                re.S)

LEFT_OVER = re.compile(r"\b(TO[D]O|FIX[M]E|HAC[K]|XX[X])\b")

CODE = {".h", ".cpp"}
SCRIPTS = {".py", ".cmake", ".sh"}
TEXT = CODE | SCRIPTS | {".ice", ".md"}
MAX_COLUMNS = 120  # of scripts; clang-format limits the columns of C++ code
SKIPPED = {"build", "resources", "__pycache__"}


@dataclass(frozen=True)
class Include:
    line: int
    name: str  # the name as written in the #include
    target: str  # the path from the root for a file of this tree, otherwise the name

    def is_of(self, part):
        return self.target.startswith(part + "/")


class SourceFile:
    def __init__(self, root, path):
        self.root = root
        self.path = path  # relative to the root
        self.name = PurePosixPath(path).name
        self.suffix = PurePosixPath(path).suffix
        self.part = path.split("/")[0]
        self.lines = (root / path).read_text(encoding="utf-8", errors="replace").split("\n")

    def is_under(self, *folders):
        return any(self.path.startswith(folder + "/") for folder in folders)

    @property
    def is_code(self):
        return self.suffix in CODE

    @property
    def is_script(self):
        return self.suffix in SCRIPTS or self.name == "CMakeLists.txt" or self.is_under("tools", ".ci")

    @property
    def is_test(self):
        return self.part == "tests" or self.name.endswith("_test.cpp")

    @property
    def core_folder(self):
        """`state` for core/tendon/state/column.h, None outside of core/tendon."""
        if self.path == ALL_OF_CORE:
            return "manager"  # the highest layer that it includes
        return self.path.split("/")[2] if self.is_under("core/tendon") else None

    @cached_property
    def includes(self):
        if not self.is_code:
            return []
        found = ((number, INCLUDE.match(line)) for number, line in enumerate(self.lines, 1))
        return [Include(number, match[1], self._target(match[1])) for number, match in found if match]

    def _target(self, name):
        if name.startswith("tendon/"):
            return "core/" + name
        beside = os.path.normpath(os.path.join(os.path.dirname(self.path), name))
        return next((p for p in (beside, name) if (self.root / p).is_file()), name)


def ice_stays_in_its_folder(file):
    if not file.is_under(*ICE_HOMES):
        for include in file.includes:
            if ICE.match(include.target):
                yield include.line, f"<{include.name}> belongs in core/tendon/ice alone; go through the middleware"


def qt_stays_in_the_window(file):
    if not file.is_under(*QT_HOMES):
        for include in file.includes:
            if QT.match(include.target):
                yield include.line, f"<{include.name}> belongs in gcm_gui alone"


def parts_include_what_they_may(file):
    allowed = PARTS.get(file.part)
    if allowed is None or file.is_test:
        return
    for include in file.includes:
        part = include.target.split("/")[0]
        if part in {*PARTS, "tests"} - allowed:
            yield include.line, f"{file.part} may not include <{include.name}>, only: {', '.join(sorted(allowed))}"


def components_need_core_alone(file):
    if file.part != "components" or file.is_test or file.is_under(*NETWORK_COMPONENTS):
        return
    for include in file.includes:
        in_core = include.target == ALL_OF_CORE or any(include.is_of(f"core/tendon/{folder}") for folder in CORE)
        standard = "/" not in include.name and "." not in include.name
        if not (in_core or standard or include.is_of("components") or include.name.startswith("Eigen/")):
            yield include.line, f"a component needs tendon::core alone, not <{include.name}>"
    if file.name == "CMakeLists.txt":
        for number, line in enumerate(file.lines, 1):
            if match := re.search(r"\b(tendon::(?!core\b)|Ice::|Qt\d?::|Qwt::)\w+", line):
                yield number, f"a component links tendon::core alone, not {match[0]}"


def layers_look_down(file):
    above = file.core_folder
    if above is None or not file.is_code:
        return
    if above not in HEIGHT:
        yield 1, f"core/tendon/{above} is no layer; the layers are: {', '.join(HEIGHT)}"
        return
    for include in file.includes:
        below = include.target.split("/")[2] if include.is_of("core/tendon") else above
        if below != above and HEIGHT.get(below, len(ROWS)) >= HEIGHT[above]:
            yield include.line, f"{above} may not include <{include.name}>, which is not below it"


def core_headers_need_the_standard_library_alone(file):
    if file.core_folder not in CORE or file.suffix != ".h":
        return
    for include in file.includes:
        ours = include.is_of("core/tendon")
        opt_in = include.name.startswith("Eigen/") and file.name.startswith("eigen")
        forward = include.name == "nlohmann/json_fwd.hpp"
        if not (ours or opt_in or forward) and ("/" in include.name or "." in include.name):
            yield include.line, f"a header of tendon::core needs the standard library alone, not <{include.name}>"


def the_operating_system_stays_in_base_os(file):
    if file.is_test or file.is_under("core/tendon/base/os"):
        return
    for include in file.includes:
        if OPERATING_SYSTEM.match(include.target):
            yield include.line, f"<{include.name}> belongs in core/tendon/base/os, behind a call of ours"


def atomics_stay_in_lockfree_and_state(file):
    if file.part not in PARTS or file.is_test or file.is_under(*ATOMIC_HOMES) or not file.is_code:
        return
    for number, line in enumerate(file.lines, 1):
        if re.search(r"<atomic>|\bstd::atomic", line.split("//")[0]):
            yield number, "atomics live in core/tendon/lockfree and state; use the classes there"


def code_has_no_macros(file):
    if not file.is_code:
        return
    for number, line in enumerate(file.lines, 1):
        if match := re.match(r"\s*#\s*define\s+(\w+)", line):
            yield number, f"{match[1]} is a macro; a template, a constant or a function says the same"


def headers_are_included_once(file):
    if file.suffix == ".h" and "#pragma once" not in file.lines:
        yield 1, "a header needs #pragma once"


def headers_name_what_they_use(file):
    """A header includes the standard header of each name that it uses, and does not rely on what others include."""
    if file.suffix != ".h" or file.part not in PARTS:
        return
    code = COMMENT_OR_LITERAL.sub(lambda match: "\n" * match[0].count("\n"), "\n".join(file.lines))
    included = {include.name for include in file.includes}
    for names, headers in STANDARD_HEADERS.items():
        if (match := names.search(code)) and included.isdisjoint(headers):
            yield code.count("\n", 0, match.start()) + 1, f"{match[0]} needs #include <{headers[0]}> in this header"


def own_header_first(file):
    """The own header of a source comes first, so that the compiler sees whether the header includes what it needs."""
    own = str(PurePosixPath(file.path).with_suffix(".h"))
    if file.suffix != ".cpp" or file.part not in PARTS or not (file.root / own).is_file():
        return
    if not file.includes:
        yield 1, f"the first include must be its own header, {own}"
    elif file.includes[0].target != own:
        yield file.includes[0].line, f"the first include must be its own header, {own}, not <{file.includes[0].name}>"


def tests_have_plain_names(file):
    if not file.is_code or not file.is_under(*PLAIN_TESTS):
        return
    text = "\n".join(file.lines)
    for match in RIDDLE.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, f"{match[1]} is a riddle; name the subject, then what it does"


def nothing_is_left_over(file):
    for number, line in enumerate(file.lines, 1):
        if match := LEFT_OVER.search(line):
            yield number, f"{match[0]}: do it, or open an issue"


def scripts_are_narrow(file):
    if not file.is_script:
        return
    for number, line in enumerate(file.lines, 1):
        if len(line) > MAX_COLUMNS:
            yield number, f"{len(line)} columns, over {MAX_COLUMNS}"


def functions_are_short(file):
    """Functions have at most 60 lines. Relies on clang-format, which puts the closing brace below the signature."""
    if not file.is_code:
        return
    head, end = 1, None  # the first line of the statement; the line that ends the function
    for number, line in enumerate(file.lines, 1):
        if end is not None:
            if line.startswith(end):
                if number - head >= MAX_FUNCTION_LINES:
                    yield head, f"a function of {number - head + 1} lines, over {MAX_FUNCTION_LINES}"
                head, end = number + 1, None
            continue
        if OPENS_BODY.search(line) and not any(map(NO_FUNCTION.match, file.lines[head - 1 : number])):
            end = re.match(r" *", file.lines[head - 1])[0] + "}"
        elif ENDS_STATEMENT.search(line):
            head = number + 1


def types_have_names_of_their_own(files):
    """Two types of the same name in one program are undefined behaviour, which no linker reports. Relies on
    clang-format, which begins definitions of a namespace in the first column."""
    seen = {}
    for file in files:
        if not file.is_code:
            continue
        for number, name in types_of(file.lines):
            if name in seen:
                yield f"{file.path}:{number}: {name} is the name of another type, in {seen[name]}"
            seen.setdefault(name, f"{file.path}:{number}")


def joined_sources_share_no_names(files):
    """Several sources of core are compiled together, so a source sees the private names of others. Equal aliases are
    allowed."""
    seen = {}
    for file in files:
        if file.core_folder is None or file.suffix != ".cpp":
            continue
        row = "core" if file.core_folder in CORE else "ice" if file.core_folder == "ice" else "network"
        for number, namespace, name, text in private_names_of(file.lines):
            place, other = seen.setdefault((row, namespace, name), (f"{file.path}:{number}", text))
            if place.split(":")[0] != file.path and text != other:
                yield f"{file.path}:{number}: {name} is private to {place}, too, and the two are compiled together"


def helpers_hide_no_declared_functions(files):
    """Several sources of a target are compiled together, so a source sees the private functions of others. It would
    call such a function instead of one that a header declares in the same namespace or in an enclosing one, without
    a warning."""
    by_path = {file.path: file for file in files if file.is_code}
    declared = {path: list(functions_of(file.lines)) for path, file in by_path.items() if file.suffix == ".h"}
    reported = set()
    for sources in sources_of_targets(files).values():
        if len(sources) < 2:
            continue
        functions = {}  # namespaces and places, by name
        for path in reachable(sources, by_path):
            for number, namespaces, name in declared.get(path, ()):
                functions.setdefault(name, []).append((namespaces, f"{path}:{number}"))
        for path in sorted(sources):
            for number, namespaces, name in helpers_of(by_path[path].lines):
                hidden = (place for around, place in functions.get(name, ()) if namespaces[:len(around)] == around)
                if (place := next(hidden, None)) and (path, number) not in reported:
                    reported.add((path, number))
                    yield (f"{path}:{number}: {name} is also the function of {place}, which another source of this "
                           f"target may mean; give the helper a name of its own")


def folders_of_a_layer_have_no_cycle(files):
    """The folders below a layer must not include each other in a cycle. Files directly in the folder of the layer are
    exempt."""
    includes = [(file, include, folder_of_layer(file.path), folder_of_layer(include.target))
                for file in files for include in file.includes]
    includes = [(file, include, above, below) for file, include, above, below in includes
                if above and below and above != below and above.split("/")[0] == below.split("/")[0]]
    below_of = {}
    for _, _, above, below in includes:
        below_of.setdefault(above, set()).add(below)
    for file, include, above, below in includes:
        if above in all_below(below, below_of):
            yield (f"{file.path}:{include.line}: {above} may not include <{include.name}>, because {below} includes "
                   f"files of {above}, itself or through others; move what both need to the lower folder")


def folder_of_layer(path):
    """`gcm/lifecycle` for core/tendon/gcm/lifecycle/a.h. None for a file that is not in a folder below a layer."""
    parts = path.split("/")
    return "/".join(parts[2:4]) if parts[:2] == ["core", "tendon"] and len(parts) > 4 else None


def all_below(folder, below_of):
    """The folders that a folder includes, directly or through other folders."""
    seen, waiting = set(), [folder]
    while waiting:
        found = below_of.get(waiting.pop(), set()) - seen
        seen |= found
        waiting.extend(found)
    return seen


def installed_headers_include_no_internal_ones(files):
    """A header in the file set HEADERS is installed. Each header of Tendon that it includes must be installed, too."""
    installed = {path for file_set, path in file_sets_of_core(files) if file_set == "HEADERS"}
    for file in files:
        if file.path not in installed:
            continue
        for include in file.includes:
            if include.is_of("core/tendon") and include.target not in installed:
                yield f"{file.path}:{include.line}: it is installed, but <{include.name}> is not: see the file sets"


def headers_of_core_are_in_a_file_set(files):
    """Only the headers in a file set are compiled by themselves."""
    listed = {path for _, path in file_sets_of_core(files)}
    built = tuple(os.path.dirname(file.path) for file in files if file.name == "CMakeLists.txt" and file.part == "core")
    for file in files:
        if file.suffix == ".h" and file.is_under(*built) and file.path not in listed:
            yield f"{file.path}:1: it is in no file set; list it in the file set internal of its layer's CMakeLists.txt"


def file_sets_of_core(files):
    """Yields the name of the file set and the path for each header in a file set of core."""
    for file in files:
        if file.name == "CMakeLists.txt" and file.part == "core":
            folder = PurePosixPath(file.path).parent
            for file_set, names in FILE_SET.findall("\n".join(file.lines)):
                yield from ((file_set, f"{folder}/{name}") for name in names.split())


def folders_are_built(files):
    """A parent folder must add each folder with a CMakeLists.txt, or a library is missing or a test never runs."""
    lists = {str(PurePosixPath(file.path).parent): "\n".join(file.lines) for file in files
             if file.name == "CMakeLists.txt"}
    for folder, text in lists.items():
        above = next((str(path) for path in PurePosixPath(folder).parents if str(path) in lists), None)
        if above is None or re.search(r"^project\(", text, re.M) or "GLOB" in lists[above]:
            continue
        named_above = re.search(rf"(?<!\w){re.escape(PurePosixPath(folder).name)}(?!\w)", lists[above])
        if not named_above and not any(f"/{folder} " in other for other in lists.values()):
            yield f"{folder}/CMakeLists.txt:1: nobody builds it; add it to {above}/CMakeLists.txt"


def folders_are_described(files):
    """Each folder with code has a line in FOLDER_PAGE, and each line has a folder."""
    page = next((file for file in files if file.path == FOLDER_PAGE), None)
    if page is None:
        return
    folders = {os.path.dirname(file.path) for file in files if file.is_code}
    parent, seen = None, set()
    for number, line in enumerate(page.lines, 1):
        if line.startswith("#"):
            match = NAMES_PARENT.match(line)
            parent = match and match[1]
        elif parent and (match := NAMES_FOLDER.match(line)):
            folder = f"{parent}/{match[1]}"
            if folder not in folders:
                yield f"{page.path}:{number}: there is no folder {folder} with code"
            if folder in seen:
                yield f"{page.path}:{number}: {folder} has a line already"
            seen.add(folder)
    for folder in sorted(folders - seen):
        if any(folder.startswith(above + "/") for above in DESCRIBED):
            yield f"{page.path}:1: {folder} has no line; add a line that says what belongs there"


def readme_names_the_layers(files):
    """The tree in README.md has a line for each layer, and only for layers."""
    page = next((file for file in files if file.path == "README.md"), None)
    if page is None:
        return
    layers = {match[1] for file in files if (match := re.match(r"core/tendon/(\w+)/", file.path))}
    named = {}
    for number, line in enumerate(page.lines, 1):
        if match := NAMES_LAYER.match(line):
            named[match[1]] = number
    for layer in sorted(set(named) - layers):
        yield f"README.md:{named[layer]}: there is no folder core/tendon/{layer}"
    for layer in sorted(layers - set(named)):
        yield f"README.md:1: the tree has no line for core/tendon/{layer}"


def tests_mirror_the_code(files):
    """Tests of core/tendon/state are in tests/core/state. TEST_PAGE names the folders without a counterpart."""
    page = next((file for file in files if file.path == TEST_PAGE), None)
    if page is None:
        return
    known = {str(above) for file in files for above in PurePosixPath(file.path).parents}
    named = {folder: number for number, line in enumerate(page.lines, 1)
             if line.startswith("| `") for folder in re.findall(r"`([\w/]+)`", line.split(" | ")[0])}
    for folder, number in named.items():
        if folder not in known:
            yield f"{page.path}:{number}: there is no folder {folder}"
    for folder in sorted({os.path.dirname(file.path) for file in files if file.is_code}):
        if folder.startswith("tests/"):
            twin = re.sub(r"^core\b", "core/tendon", folder.removeprefix("tests/"))
        elif any(f"{folder}/".startswith(f"{part}/") for part in MIRRORED):
            twin = "tests/" + folder.replace("core/tendon", "core", 1)
        else:
            continue
        above = {folder, *map(str, PurePosixPath(folder).parents)}
        if twin not in known and not above & named.keys():
            yield f"{page.path}:1: {folder} has no counterpart, {twin}; move it, or name it here with the reason"


def sources_of_targets(files):
    """The .cpp files of each target in all CMakeLists.txt."""
    known = {file.path for file in files if file.suffix == ".cpp"}
    targets = {}
    for file in files:
        if file.name != "CMakeLists.txt":
            continue
        folder = os.path.dirname(file.path)
        text = "\n".join(line.split("#")[0] for line in file.lines)
        for target, names in LISTS_SOURCES.findall(text):
            paths = {os.path.normpath(os.path.join(folder, name)) for name in names.split()}
            targets.setdefault(target, set()).update(paths & known)
    return targets


def reachable(sources, by_path):
    """The sources, and all files that they include directly or through others."""
    seen, waiting = set(), list(sources)
    while waiting:
        path = waiting.pop()
        if path in by_path and path not in seen:
            seen.add(path)
            waiting.extend(include.target for include in by_path[path].includes)
    return seen


def functions_of(lines):
    """Yields the functions of named namespaces: line number, enclosing namespaces, name."""
    for number, namespaces, line in in_namespaces(lines):
        if all(namespaces) and (name := function_name(line)):
            yield number, names_in(namespaces), name


def helpers_of(lines):
    """Yields the functions, constants, types and aliases of unnamed namespaces, in the form of functions_of()."""
    for number, namespaces, line in in_namespaces(lines):
        if not namespaces[-1]:
            match = PRIVATE_NAME.match(line)
            name = next(group for group in match.groups() if group) if match else function_name(line)
            if name:
                yield number, names_in(namespaces), name


def names_in(namespaces):
    """Splits ("a::b", "") into ("a", "b")."""
    return tuple(name for one in namespaces for name in one.split("::") if name)


def function_name(line):
    """The name of the function whose declaration begins in this line; None if there is none."""
    if NO_NAMED_FUNCTION.match(line) or "(" not in line:
        return None
    line = line.replace("decltype(auto)", "auto")
    while (shorter := TEMPLATE_ARGUMENTS.sub("", line)) != line:
        line = shorter
    head = re.sub(r"\[\[.*?\]\]", "", line).split("(")[0]
    match = None if "=" in head or "{" in head else FUNCTION_NAME.search(head)
    return match and match[1]


def private_names_of(lines):
    """Yields constants, types and aliases of unnamed namespaces: line number, enclosing namespace, name, and a text.
    Only equal aliases have equal texts."""
    for number, namespaces, line in in_namespaces(lines):
        if not namespaces[-1] and (match := PRIVATE_NAME.match(line)):
            name = next(group for group in match.groups() if group)
            yield number, "::".join(namespaces), name, line if line.startswith("using") else f"{number} {line}"


def types_of(lines):
    """Yields the types of named namespaces: line number, name."""
    for number, namespaces, line in in_namespaces(lines):
        if all(namespaces) and (match := DEFINES_TYPE.match(line)):
            yield number, "::".join((*namespaces, match[1]))


def in_namespaces(lines):
    """Yields each line in a namespace: number, enclosing namespaces (the outermost first), text."""
    namespaces = []
    for number, line in enumerate(lines, 1):
        if match := OPENS_NAMESPACE.match(line):
            namespaces.append(match[1])
        elif line.startswith("}  // namespace") and namespaces:
            namespaces.pop()
        elif namespaces:
            yield number, tuple(namespaces), line


FILE_RULES = (
    ice_stays_in_its_folder, qt_stays_in_the_window, parts_include_what_they_may, components_need_core_alone,
    layers_look_down, core_headers_need_the_standard_library_alone, the_operating_system_stays_in_base_os,
    atomics_stay_in_lockfree_and_state, code_has_no_macros, headers_are_included_once, headers_name_what_they_use,
    own_header_first, tests_have_plain_names, nothing_is_left_over, scripts_are_narrow, functions_are_short)
TREE_RULES = (types_have_names_of_their_own, joined_sources_share_no_names, helpers_hide_no_declared_functions,
              folders_of_a_layer_have_no_cycle, installed_headers_include_no_internal_ones,
              headers_of_core_are_in_a_file_set, folders_are_built, folders_are_described, readme_names_the_layers,
              tests_mirror_the_code)


def folders_of(root):
    """Yields each folder of the tree with its files, except for build trees, hidden folders and resources."""
    for current, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in SKIPPED and (f[0] != "." or f == ".ci"))
        yield Path(current).relative_to(root).as_posix(), sorted(files)


def is_source(folder, name):
    return PurePosixPath(name).suffix in TEXT or name == "CMakeLists.txt" or folder in {"tools", ".ci"}


def violations(root):
    root = Path(root)
    files = []
    for folder, names in folders_of(root):
        for name in names:
            if is_source(folder, name):
                file = SourceFile(root, name if folder == "." else f"{folder}/{name}")
                files.append(file)
                for rule in FILE_RULES:
                    yield from (f"{file.path}:{line}: {sentence}" for line, sentence in rule(file))
    for rule in TREE_RULES:
        yield from rule(files)


def main():
    root = Path(sys.argv[1])
    found = [f"{page}:1: there is no such page; the tables of the folders belong there"
             for page in (FOLDER_PAGE, TEST_PAGE) if not (root / page).is_file()]
    found += violations(root)
    for violation in found:
        print(violation)
    print(f"{len(found)} violations of the architecture" if found else "The tree keeps its architecture.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
