"""What is to be known of the machines that runs were made on."""


def machine_rows(machine):
    """(name, text) of a machine.json; of unknown facts why they are."""
    rows = [(key, machine[key]) for key in ("cpu", "cores", "pus", "packages", "compiler", "kernel", "load") if key in machine]
    rows += [(key, value) for key, value in machine.get("build", {}).items() if key in ("commit", "type", "flags")]
    facts = machine.get("facts", {})
    for key in ("governor", "turbo", "virtual_machine", "container", "smt", "clock_source"):
        fact = facts.get(key)
        if fact:
            state = str(fact["state"])
            rows.append((key, state if state != "unknown" else f"unknown: {fact['reason']}"))
    return [(key.replace("_", " "), str(value)) for key, value in rows]


def grouped(titled):
    """(titles, rows) a machine, of pairs of a title and a machine.json: what is the same machine by the same build stands together."""
    groups = {}
    for title, machine in titled:
        groups.setdefault(tuple(machine_rows(machine)), []).append(title)
    return [("; ".join(titles), rows) for rows, titles in groups.items()]
