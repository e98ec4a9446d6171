"""The page reads whole numbers by the command's rule: both are tested with one table."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]


class WholeNumbers(unittest.TestCase):
    def test_are_those_of_the_command(self):
        table = json.loads((ROOT / "tests/recipes/whole_numbers.json").read_text())
        texts = [*table["taken"], *table["refused"]]
        with tempfile.TemporaryDirectory() as folder:
            # node takes a module by its extension.
            shutil.copy(ROOT / "web/page/command.js", f"{folder}/command.mjs")
            script = f"""import {{ wholeNumber }} from "{folder}/command.mjs";
                console.log(JSON.stringify({json.dumps(texts)}.map(wholeNumber)));"""
            node = ["node", "--input-type=module", "-e", script]
            found = json.loads(subprocess.run(node, check=True, capture_output=True).stdout)
        self.assertEqual(found, [*table["taken"].values(), *([None] * len(table["refused"]))])


if __name__ == "__main__":
    unittest.main()
