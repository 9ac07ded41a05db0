#!/usr/bin/env python3
"""Reads a JUnit file as a CI does: by its elements, with a parser that is not ours."""

import collections
import sys
import xml.etree.ElementTree

root = xml.etree.ElementTree.parse(sys.argv[1]).getroot()
assert root.tag == "testsuites", root.tag
names, seen = set(), collections.Counter()
for suite in root:
    counted = collections.Counter()
    for case in suite.iter("testcase"):
        name = case.get("classname"), case.get("name")
        assert None not in name and name not in names, f"{name} is missing or given twice"
        names.add(name)
        assert float(case.get("time", 0)) >= 0
        children = list(case)
        assert len(children) <= 1, name
        status = children[0].tag if children else "passed"
        counted[status] += 1
        if children:
            assert children[0].get("message") and children[0].text.strip(), f"{name}: {status} without a word"
            assert status == "error" or children[0].get("message").split()[0] in children[0].text, name
    for attribute, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped")):
        assert int(suite.get(attribute)) == counted[tag], (suite.get("name"), attribute)
    assert int(suite.get("tests")) == sum(counted.values()), suite.get("name")
    seen += counted
print(f"JUnit: {len(names)} test cases: " + ", ".join(f"{count} {status}" for status, count in sorted(seen.items())))
for status in ("passed", "failure", "skipped"):
    assert seen[status], f"none that is {status}"
