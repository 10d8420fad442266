"""`lagsolve grade`: many submissions to one problem, each within limits of time and memory."""
