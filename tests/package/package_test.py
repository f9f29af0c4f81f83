# SPDX-License-Identifier: MIT
# Manual page, completions and Debian package. In: the program, the build's folder. Shells that are not there are left out, and told.
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, BUILD = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
DOCUMENTS = os.path.join(BUILD, "documents")
VERBS = ("match", "symmetry", "points", "transfer", "dense", "morph", "params")


def needs(*programs):
    missing = [program for program in programs if not shutil.which(program)]
    return unittest.skipIf(missing, f"no {', '.join(missing)}")


def output_of(*words, **how):
    return subprocess.run(words, check=True, capture_output=True, text=True, timeout=300, **how).stdout


def document(kind):
    with open(os.path.join(DOCUMENTS, "homolog." + kind), encoding="utf-8") as file:
        return file.read()


def options_of(verb):
    """The options that --help shows."""
    return set(re.findall(r"^\s+(?:-\w,)?(--[\w-]+)", output_of(PROGRAM, verb, "--help"), re.M))


class ManualPage(unittest.TestCase):
    def test_it_names_all_verbs_and_options(self):
        text = document("man").replace("\\-", "-")
        for verb in VERBS:
            self.assertIn(f".SS homolog {verb}", text)
            for option in options_of(verb):
                self.assertIn(f"\\fB{option}\\fR", text)

    @needs("groff")
    def test_groff_has_no_complaint(self):
        run = subprocess.run(["groff", "-man", "-ww", "-Tutf8", os.path.join(DOCUMENTS, "homolog.man")], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    @needs("mandoc")
    def test_mandoc_has_no_complaint(self):
        run = subprocess.run(["mandoc", "-Tlint", "-Werror", os.path.join(DOCUMENTS, "homolog.man")], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stdout), (0, ""))


class Completions(unittest.TestCase):
    def of_bash(self, *words):
        script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _homolog; printf "%s\\n" "${COMPREPLY[@]}"'
        command = ["bash", "--norc", "-c", "compopt() { :; }; " + script, "bash", os.path.join(DOCUMENTS, "homolog.bash")]
        return output_of(*command, "homolog", *words).split()

    @needs("bash")
    def test_bash(self):
        self.assertEqual(self.of_bash("ma"), ["match"])
        self.assertEqual(set(VERBS) - set(self.of_bash("")), set())
        self.assertEqual(self.of_bash("match", "--mir"), ["--mirror"])
        self.assertEqual(self.of_bash("match", "a.off", "--mirror", ""), ["allow", "forbid", "only"])
        self.assertEqual(self.of_bash("transfer", "--inv"), ["--inverse"])
        self.assertEqual(self.of_bash("match", "a.o"), [])
        for verb in VERBS:
            self.assertEqual(set(self.of_bash(verb, "--")), options_of(verb))

    @needs("fish")
    def test_fish(self):
        def completed(line):
            words = output_of("fish", "--no-config", "-c", f'source {DOCUMENTS}/homolog.fish; complete -C "{line}"')
            return [word.split("\t")[0] for word in words.splitlines()]

        self.assertEqual(completed("homolog ma"), ["match"])
        self.assertEqual(completed("homolog match --mir"), ["--mirror"])
        self.assertEqual(completed("homolog match --mirror "), ["allow", "forbid", "only"])
        for verb in VERBS:
            self.assertEqual(set(completed(f"homolog {verb} --")), options_of(verb))

    @needs("zsh")
    def test_zsh(self):
        # What the script hands to zsh's own _arguments, for a verb, and whether that takes it as specifications.
        script = f"""
          compdef() {{ : }}
          source {DOCUMENTS}/homolog.zsh
          _describe() {{ print -rl -- $verbs }}
          _arguments() {{ [[ $1 == -C ]] && state=$wanted || print -rl -- "$@" }}
          wanted=$1; words=($2); _homolog"""
        self.assertIn("match:Find every place where MODEL, or a part of it, occurs in DATA.", output_of("zsh", "-f", "-c", script, "zsh", "verb"))
        for verb in VERBS:
            rows = output_of("zsh", "-f", "-c", script, "zsh", "rest", verb).splitlines()
            self.assertEqual({row.split("[")[0].rstrip("=") for row in rows if row.startswith("--")}, options_of(verb))
        self.assertIn(":WORD:(allow forbid only)", output_of("zsh", "-f", "-c", script, "zsh", "rest", "match"))

    def test_generate_is_not_shown_and_refuses_other_kinds(self):
        self.assertNotIn("generate", output_of(PROGRAM, "--help"))
        run = subprocess.run([PROGRAM, "generate", "tcsh"], capture_output=True, text=True)
        self.assertEqual((run.returncode, run.stderr), (2, "homolog: cannot generate 'tcsh'; there are man, bash, zsh and fish\n"))


class Package(unittest.TestCase):
    @needs("cpack", "dpkg-deb", "dpkg-shlibdeps", "file")
    def test_debian_packages(self):
        with tempfile.TemporaryDirectory() as folder:
            output_of("cpack", "-G", "DEB", "-B", folder, cwd=BUILD)
            packages = {name.split("_")[0]: os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".deb")}
            self.assertEqual(set(packages), {"homolog", "libhomolog-dev"})
            depends = {name: output_of("dpkg-deb", "-f", package, "Depends") for name, package in packages.items()}
            for library in ("libassimp", "libtbb", "libc6", "libstdc++6", "zlib1g"):
                self.assertIn(library, depends["homolog"])
            for library in ("libeigen3-dev", "libassimp-dev", "libtbb-dev", "libfmt-dev", "zlib1g-dev"):
                self.assertIn(library, depends["libhomolog-dev"])
            files = {name: [line.split()[-1].removeprefix("./") for line in output_of("dpkg-deb", "-c", package).splitlines()]
                     for name, package in packages.items()}
            for name in ("bin/homolog", "share/man/man1/homolog.1.gz", "share/bash-completion/completions/homolog",
                         "share/zsh/vendor-completions/_homolog", "share/fish/vendor_completions.d/homolog.fish"):
                self.assertIn("usr/" + name, files["homolog"])
            for name in ("include/homolog/homolog.h", "lib/libhomolog.a", "lib/cmake/homolog/homologConfig.cmake"):
                self.assertIn("usr/" + name, files["libhomolog-dev"])
            for package, names in files.items():
                for name in ("copyright", "changelog.gz"):
                    self.assertIn(f"usr/share/doc/{package}/{name}", names)
                self.assertEqual([name for name in names if not name.startswith("usr/")], [])
            self.assertEqual([name for name in set(files["homolog"]) & set(files["libhomolog-dev"]) if not name.endswith("/")], [])
            output_of("dpkg-deb", "-x", packages["homolog"], os.path.join(folder, "root"))
            self.assertRegex(output_of(os.path.join(folder, "root/usr/bin/homolog"), "--version"), r"^homolog \d")

    @needs("cpack", "dpkg-deb", "dpkg-shlibdeps", "lintian")
    def test_lintian_finds_nothing_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            output_of("cpack", "-G", "DEB", "-B", folder, cwd=BUILD)
            packages = [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".deb")]
            output_of("lintian", "--allow-root", "--fail-on", "error,warning", *packages)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
