"use strict";
// The slider opens the pictures of one instant and closes those of the others.
const slider = document.getElementById("instant");
if (slider) {
  const instants = document.querySelectorAll(".instant"), times = slider.dataset.times.split(";");
  const show = () => {
    instants.forEach((instant, i) => { instant.open = i === slider.valueAsNumber; });
    const text = "t = " + times[slider.valueAsNumber];
    slider.setAttribute("aria-valuetext", text);
    document.querySelector(".slider output").value = text;
  };
  slider.closest(".slider").hidden = false;
  slider.closest("section").classList.add("moved");
  slider.addEventListener("input", show);
  show();
}
