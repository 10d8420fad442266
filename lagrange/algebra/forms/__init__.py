"""Differential forms: exactness, integrability (Frobenius), integrating factors, hidden finite relations."""
