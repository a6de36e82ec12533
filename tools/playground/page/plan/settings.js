// The settings of a planner as fields: what differs from its default goes to the engine.

const by = (id) => document.getElementById(id);

/** A choice of words, on and off among them, or a number. */
function control(setting) {
  const words = setting.switch ? ["on", "off"] : setting.words;
  if (words?.length > 0) {
    const list = document.createElement("select");
    list.append(...words.map((word) => new Option(word, word)));
    list.value = setting.default;
    return list;
  }
  const input = Object.assign(document.createElement("input"), { type: "number", min: setting.min, max: setting.max, step: setting.whole ? 1 : "any" });
  input.value = setting.default;
  return input;
}

export class PlannerSettings {
  /** onChange(values): values are {key: text} of the settings that are not as they were made. */
  constructor(planners, onChange) {
    Object.assign(this, { planners, onChange, values: {} });
  }

  /** Shows the fields of a planner, all at their defaults. */
  show(name) {
    const { settings = [] } = this.planners.find((planner) => planner.name === name) ?? {};
    this.values = {};
    by("settings-title").textContent = `Settings of ${name}`;
    by("settings").replaceChildren(...settings.map((setting) => {
      const label = document.createElement("label");
      const field = control(setting);
      label.title = [setting.meaning, setting.unit].filter(Boolean).join(", ");
      label.append(setting.key, field);
      field.addEventListener("change", () => this.change(setting, field));
      return label;
    }));
  }

  change(setting, field) {
    if (!field.reportValidity()) return;
    if (field.value === "" || field.value === setting.default) {
      field.value = setting.default;
      delete this.values[setting.key];
    } else {
      this.values[setting.key] = field.value;
    }
    this.onChange(this.values);
  }
}
