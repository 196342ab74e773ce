"""What is said of the package in several places."""

import tomllib

import yaml

from tests.places import CHECKOUT

PROJECT = tomllib.loads((CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))


def test_recipe_and_citation_say_what_the_project_says():
    recipe = yaml.safe_load((CHECKOUT / "recipe/recipe.yaml").read_text(encoding="utf-8"))
    citation = yaml.safe_load((CHECKOUT / "CITATION.cff").read_text(encoding="utf-8"))
    project = PROJECT["project"]
    assert recipe["context"]["version"] == citation["version"] == project["version"]
    runs = [entry.replace(" ", "") for entry in recipe["requirements"]["run"]]
    assert sorted(runs) == sorted(["python", *project["dependencies"]])
    host = [entry.replace(" ", "") for entry in recipe["requirements"]["host"]]
    assert set(PROJECT["build-system"]["requires"]) < set(host)
    assert recipe["about"]["summary"] == project["description"]
    assert recipe["about"]["license"] == citation["license"] == project["license"]
    assert citation["abstract"].rstrip(".") == project["description"]


def test_workflows_are_read_and_run_what_is_there():
    folder = CHECKOUT / ".github" / "workflows"
    flows = {path.stem: yaml.safe_load(path.read_text("utf-8")) for path in folder.glob("*.yml")}
    assert set(flows) == {"docs", "release", "tests"}
    for flow in flows.values():
        assert flow["permissions"] == {"contents": "read"}
        for job in flow["jobs"].values():
            for step in job["steps"]:
                for word in step.get("run", "").split():
                    if word.startswith((".ci/", "tests/", "docs")):
                        assert (CHECKOUT / word).exists(), word
    publish = flows["release"]["jobs"]["publish"]
    assert publish["permissions"] == {"id-token": "write"}
    assert publish["environment"] == "release"
