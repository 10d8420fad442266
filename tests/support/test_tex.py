from tests.support.tex import faults_of_labels


def test_labels_and_references() -> None:
    assert faults_of_labels(r"\label{a} \eqref{a} \label{b}") == []
    assert faults_of_labels(r"\label{a} \label{a} \ref{c}") == ["label a repeated", "label c undefined"]
