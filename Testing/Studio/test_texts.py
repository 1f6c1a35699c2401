"""Whatever the Studio says can be translated: no sentence in its sources stands outside tr()."""
import os
import pathlib
import re

STUDIO = pathlib.Path(os.environ["OVERSKETCH_SOURCE"]) / "Applications" / "Studio"
STRING = r'"(?:[^"\\\n]|\\.)*"'
TRANSLATED = re.compile(r"(?:\btr\(|\btranslate\(\s*%s,|QT_TRANSLATE_NOOP\(\s*%s,)\s*%s(?:\s*%s)*" % ((STRING,) * 4))
# What no person reads, or a terminal shows.
NOT_READ = re.compile(r'setObjectName\(%s\)|fprintf\([^;]*;|#include[^\n]*|(?:create|toString|startsWith|shippedFile)\(%s\)|\{ %s, (?=QT_TR)|[!=]= %s|(?:constexpr const char\*|const char\* const) \w+ = %s|translate\(%s, (?!")|R"\(.*?\)"'
                      r'|(?:change\(|findParameter\(\*\w+, |findSystem\(|HeldStrokeTool\(|\.find\(|values\[|valueOr\([\w.]+, |GetInnerOutput\(|GetArray\()%s'
                      r'|\{ %s, this->|options\.\w+\(%s|length : \{ %s, %s|\{ %s(?:\s*%s)*,(?=\s*QT_TR)|\{ %s, (?=line|ring|begins|isRing)|unusable\(%s|system\(\) const override \{ return %s|isOf\(\w+, %s|QStringList\{ [^}]* \}\.contains\(' % ((STRING,) * 17), re.S)
SENTENCE = re.compile(r"[A-Za-z]{2,}[,.:]? [A-Za-z]|^\"[A-Z][a-z]+\"$")


def untranslated(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = TRANSLATED.sub("", NOT_READ.sub("", text))
    return [string for string in re.findall(STRING, text) if SENTENCE.search(string)]


def test_no_sentence_is_fixed():
    sources = [path for suffix in ("cxx", "h") for path in STUDIO.rglob("*." + suffix) if path.stem != "latency" and path.parent.name != "Testing"]
    assert len(sources) > 5
    assert {path.name: untranslated(path.read_text()) for path in sources if untranslated(path.read_text())} == {}


def test_a_fixed_sentence_is_found():
    assert untranslated('box.setText("All is lost.");') == ['"All is lost."']
    assert untranslated('box.setText(tr("All is " "lost."));') == []
    assert untranslated('add(menu, "Save", {});') == ['"Save"']


def test_messages_with_words_of_the_windows_own_are_said_by_some_step():
    table = (STUDIO / "Window" / "message_text.cxx").read_text()
    ids = ["".join(re.findall(STRING, text)).replace('""', "") for text in re.findall(r"\{ (%s(?:\s*%s)*),\s*QT_TR" % (STRING, STRING), table)]
    assert len(ids) > 15
    sources = [path for room in ("Kernels", "Filters") for path in (STUDIO.parents[1] / room).rglob("*.cxx") if "est" not in path.stem]
    said = {"".join(re.findall(STRING, text)).replace('""', "") for path in sources for text in re.findall(r"%s(?:\s*%s)*" % (STRING, STRING), path.read_text())}
    assert [one for one in ids if one not in said] == []
