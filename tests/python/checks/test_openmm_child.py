# SPDX-License-Identifier: MIT
"""Whatever OpenMM does to its process, there is an outcome for each job."""

import numpy as np
import pytest
from hanging import clock_that_waits_for
from pliant.checks.openmm import child
from pliant.checks.openmm.child import Job, run_jobs

import pliant


def chain(**more):
    """Constrain a chain of three atoms, one bar of which is 1 % too long."""
    arrays = {
        "masses": np.full(3, 12.0),
        "bars": np.array([[0, 1], [1, 2]]),
        "rest_lengths": np.array([0.1, 0.1]),
        "broken": np.array([[[[-0.101, 0, 0], [0, 0, 0], [0, 0.1, 0]]]]),
    }
    values = {"platform": "Reference", "tolerance": 1e-6, "repeats": 2, "budget_seconds": 9.0}
    for name, value in more.items():
        (arrays if isinstance(value, np.ndarray) else values)[name] = value
    return Job("apply_constraints", values, arrays)


def test_a_job_is_done():
    (outcome,), version = run_jobs([chain()])
    assert outcome.done and outcome.brief() == "done"
    positions = outcome.arrays["positions"][0, 0]
    assert np.linalg.norm(positions[1] - positions[0]) == pytest.approx(0.1, rel=1e-6)
    assert version


def test_an_exception_is_reported_and_costs_no_other_job():
    massless = chain(masses=np.array([12.0, 0.0, 12.0]))
    outcomes, _ = run_jobs([massless, chain()])
    assert outcomes[0].brief() == (
        "raised an exception: A constraint cannot involve a massless particle"
    )
    assert outcomes[1].done


@pytest.fixture
def worker(tmp_path, monkeypatch):
    """A worker whose every second job ends as the test says."""

    def install(ending):
        text = child.WORKER.read_text()
        marker = "    jobs = json.loads"
        assert marker in text
        script = tmp_path / "worker.py"
        script.write_text(
            text.replace(marker, f"    KINDS['bond_energies'] = lambda job: {ending}\n{marker}")
        )
        monkeypatch.setattr(child, "WORKER", script)

    return install


@pytest.mark.parametrize(
    ("ending", "brief"),
    [
        ("__import__('os').abort()", "died: SIGABRT"),
        ("__import__('os')._exit(3)", "died: exit code 3"),
        (
            "(print('QUERN: assert', file=sys.stderr), __import__('os').abort())",
            "died: SIGABRT, QUERN: assert",
        ),
    ],
)
def test_a_dead_process_is_an_outcome_and_the_next_job_is_done(worker, ending, brief):
    worker(ending)
    fatal = Job("bond_energies", {}, {})
    outcomes, _ = run_jobs([chain(), fatal, chain(), fatal])
    assert [o.brief() for o in outcomes] == ["done", brief, "done", brief]


def test_a_process_that_hangs_is_ended_and_the_next_job_is_done(worker, monkeypatch):
    worker("__import__('time').sleep(3600)")
    jobs = [chain(), Job("bond_energies", {}, {}), chain()]
    outcomes, _ = run_jobs(jobs, 4.0, clock_that_waits_for(2, monkeypatch))
    assert [o.brief() for o in outcomes] == ["done", "took more than 4 s", "done"]


def test_an_openmm_that_cannot_be_imported_is_an_error_of_one_line(tmp_path, monkeypatch):
    script = tmp_path / "worker.py"
    script.write_text("import no_such_openmm\n")
    monkeypatch.setattr(child, "WORKER", script)
    with pytest.raises(pliant.InputError) as error:
        run_jobs([chain()])
    assert str(error.value) == (
        "OpenMM could not be started: ModuleNotFoundError: No module named 'no_such_openmm'"
    )


def test_progress_counts_jobs():
    seen = []
    run_jobs([chain(), chain()], progress=lambda done, total: seen.append((done, total)))
    assert seen and all(total == 2 and done <= 2 for done, total in seen)
